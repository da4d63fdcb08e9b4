/** Whether the controller has told the page anything, and whether what it told still holds: an empty list may mean that nobody knows. */
import { computed } from "@preact/signals";
import { heardAt, inPast, link, pastShown } from "./store";
import { clock } from "./shows";
import { t } from "./texts";

/** The controller has told the page something since it was opened; of the past: there is a moment that is shown. */
export const answered = computed(() => (inPast.value ? pastShown.value : heardAt.value > 0));

/** What is shown is what was, since the controller does not answer. */
export const away = computed(() => link.value !== "live" && heardAt.value > 0);

/** When it was heard last, as time of day at this place. */
export const lastHeard = (): string => clock(new Date(heardAt.value).toISOString());

/** What stands in an empty list: the words for that there is nothing, or that nobody knows. */
export function none(words: string): string {
  if (inPast.value) return pastShown.value ? words : t("not_known_then");
  if (heardAt.value === 0) return t("not_known_yet");
  return link.value === "live" ? words : t("not_known_since", lastHeard());
}

/** A count, or a dash where nobody knows. */
export const counted = (count: number): number | string => (answered.value ? count : "–");
