/**
 * Every word of the page, in both languages, from the catalogue that the API and the command line speak from as well
 * (app/texts). What the server says in sentences is translated by the catalogue's sayings where it has them.
 */
import { signal } from "@preact/signals";
import { events as happens, page as en, sayings as told } from "../../app/texts/en.json";
import { events as happened, page as ko, sayings as retold } from "../../app/texts/ko.json";
import { Sayings } from "./sayings";

export type Language = "en" | "ko";
export type Word = keyof typeof en;

const KEPT = "hoistway.language";
const kept = localStorage.getItem(KEPT);
export const language = signal<Language>(kept === "en" || kept === "ko" ? kept : navigator.language.startsWith("ko") ? "ko" : "en");
const sayings = new Sayings(told, retold);

export function speak(next: Language): void {
  localStorage.setItem(KEPT, next);
  language.value = next;
  document.documentElement.lang = next;
}

/** A word or sentence; {0}, {1} … are replaced. */
export function t(word: Word, ...values: (string | number)[]): string {
  const text: string = (language.value === "ko" ? ko : en)[word];
  return values.reduce<string>((sentence, value, i) => sentence.replace(`{${i}}`, String(value)), text);
}

/** The server's word for a state, translated if we know it. */
export function said(word: string): string {
  return Object.hasOwn(en, word) ? t(word as Word) : word.replaceAll("_", " ");
}

/** A sentence of the server, translated as far as the catalogue knows it. */
export function tell(sentence: string): string {
  if (language.value === "en") return sentence;
  return Object.hasOwn(ko, sentence) ? said(sentence) : sayings.translate(sentence);
}

/** An event of SEMI E82 in words: VehicleAcquireStarted -> Vehicle acquire started. */
export function happening(event: string): string {
  const known = (language.value === "ko" ? happened : happens) as Record<string, string>;
  return known[event] ?? event.replace(/([a-z])([A-Z])/g, "$1 $2");
}
