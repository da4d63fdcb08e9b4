/** Sentences of the server in another language: by their patterns, since they come with names and numbers filled in. Pure. */

interface Saying {
  /** Its longest fixed part: looked for first, since that is quick. */
  fixed: string;
  pattern: RegExp;
  other: string;
  /** Letters that are no slot: the pattern with most of them is tried first. */
  weight: number;
}

/** Sentences within sentences are translated too, so deep. */
const DEPTH = 4;
const KEPT = 2000;

export class Sayings {
  private readonly list: Saying[];
  private readonly known = new Map<string, string>();

  /** What a sentence has in it that comes out otherwise; null: any may. */
  private readonly marks: string[] | null;

  /** Two catalogues of the same keys; {0}, {1} … are slots. `only`: the keys for which the two differ, if few. */
  constructor(from: Record<string, string>, to: Record<string, string>, only?: string[]) {
    this.marks = only?.map((key) => fixedOf(from[key] ?? "")) ?? null;
    this.list = Object.entries(from).map(([key, text]) => ({
      fixed: fixedOf(text),
      pattern: patternOf(text),
      other: to[key] ?? text,
      weight: text.replace(/\{\d\}/g, "").length,
    }));
    this.list.sort((a, b) => b.weight - a.weight);
  }

  translate(sentence: string): string {
    if (!sentence || this.marks?.every((mark) => !sentence.includes(mark))) return sentence;
    const known = this.known.get(sentence);
    if (known !== undefined) return known;
    const found = this.retold(sentence, DEPTH);
    if (this.known.size >= KEPT) this.known.clear();
    this.known.set(sentence, found);
    return found;
  }

  private retold(sentence: string, depth: number): string {
    for (const { fixed, pattern, other } of this.list) {
      const match = sentence.includes(fixed) ? pattern.exec(sentence) : null;
      if (!match) continue;
      return other.replace(/\{(\d)\}/g, (_, slot: string) => {
        const part = match.groups?.[`s${slot}`] ?? "";
        return depth > 0 && part.includes(" ") ? this.retold(part, depth - 1) : part;
      });
    }
    // A reason, and what would help.
    const end = sentence.indexOf("; ");
    if (end < 0 || depth === 0) return sentence;
    return `${this.retold(sentence.slice(0, end), depth - 1)}; ${this.retold(sentence.slice(end + 2), depth - 1)}`;
  }
}

const fixedOf = (text: string): string => text.split(/\{\d\}/).reduce((longest, part) => (part.length > longest.length ? part : longest), "");

/** What stands first is a name, or several: a clause within a sentence is none by itself. */
function patternOf(text: string): RegExp {
  const pieces = text.split(/(\{\d\})/).filter(Boolean);
  const parts = pieces.map((part, i) => {
    const slot = /^\{(\d)\}$/.exec(part);
    return slot ? `(?<s${slot[1]}>${i === 0 ? "\\S+?(?: \\(for \\S+?\\))?(?:, \\S+?)*?" : ".+?"})` : part.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");
  });
  return new RegExp(`^${parts.join("")}$`, "s");
}
