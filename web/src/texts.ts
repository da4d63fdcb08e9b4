/**
 * Every word of the page, in both languages, from the catalogue that the API and the command line speak from as well
 * (app/texts). What the server says in sentences is translated by the catalogue's sayings where it has them.
 */
import { signal } from "@preact/signals";
import { events as happens, names, page as en, pages as inEnglish, remedies, sayings as told } from "../../app/texts/en.json";
import { events as happened, names as called, page as ko, pages as inKorean, remedies as helps, sayings as retold } from "../../app/texts/ko.json";
import { roomOf } from "./rooms";
import { settled } from "./particles";
import { Sayings } from "./sayings";

export type Language = "en" | "ko";
export type Word = keyof typeof en;

const KEPT = "hoistway.language";
const kept = localStorage.getItem(KEPT);
export const language = signal<Language>(kept === "en" || kept === "ko" ? kept : navigator.language.startsWith("ko") ? "ko" : "en");
/** What helps is said by the server in words of its API; where that names a call, the page names its button or room (`pages`). */
const english = new Sayings(told, { ...told, ...inEnglish }, Object.keys(inEnglish));
const under = (section: string, words: Record<string, string>): Record<string, string> =>
  Object.fromEntries(Object.entries(words).map(([key, text]) => [`${section} ${key}`, text]));
const korean = new Sayings(
  { ...told, ...under("remedy", remedies), ...under("name", names) },
  { ...retold, ...inKorean, ...under("remedy", helps), ...under("name", called) },
);

export function speak(next: Language): void {
  localStorage.setItem(KEPT, next);
  language.value = next;
  document.documentElement.lang = next;
}

/** A word or sentence; {0}, {1} … are replaced. */
export function t(word: Word, ...values: (string | number)[]): string {
  const text: string = (language.value === "ko" ? ko : en)[word];
  const filled = values.reduce<string>((sentence, value, i) => sentence.replace(`{${i}}`, String(value)), text);
  return language.value === "ko" && values.length > 0 ? settled(filled) : filled;
}

/** The server's word for a state, translated if we know it. */
export function said(word: string): string {
  return Object.hasOwn(en, word) ? t(word as Word) : word.replaceAll("_", " ");
}

/** A sentence of the server, translated as far as the catalogue knows it, with the page's names for what it says to call. */
export function tell(sentence: string): string {
  if (language.value === "ko" && Object.hasOwn(ko, sentence)) return said(sentence);
  if (language.value === "ko") return settled(withRooms(korean.translate(sentence)));
  return withRooms(english.translate(sentence));
}

const CALL = /(?:\b(?:GET|POST|PUT|PATCH|DELETE) )?\/api\/v1\/([a-z]+)(?:\/[\w/:-]+)?/g;

/** A path of the API that a sentence has filled in, as the room where that is to be seen. */
function withRooms(sentence: string): string {
  if (!sentence.includes("/api/v1/")) return sentence;
  return sentence.replace(CALL, (path: string, first: string) => {
    const word = roomOf(first);
    return word ? t("the_room", t(word as Word)) : path;
  });
}

/** An event of SEMI E82 in words: VehicleAcquireStarted -> Vehicle acquire started. */
export function happening(event: string): string {
  const known = (language.value === "ko" ? happened : happens) as Record<string, string>;
  return known[event] ?? event.replace(/([a-z])([A-Z])/g, "$1 $2");
}
