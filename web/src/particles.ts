/** Korean particles go by the sound before them, as app/texts/particles.py has it for the API and the command line. Pure. */

/** After ㄹ (l) it is 로, not 으로; else ㄹ is a consonant like the others. */
type Sound = "vowel" | "consonant" | "l";

/** As the texts write them: after a vowel, after a consonant. */
const FORMS: Record<string, [string, string]> = {
  "이(가)": ["가", "이"],
  "은(는)": ["는", "은"],
  "을(를)": ["를", "을"],
  "과(와)": ["와", "과"],
  "와(과)": ["와", "과"],
  "(으)로": ["로", "으로"],
  "(이)라": ["라", "이라"],
  "(이)나": ["나", "이나"],
  "(이)고": ["고", "이고"],
  "(이)며": ["며", "이며"],
};
const FORM = new RegExp(`(?<=\\S) ?(${Object.keys(FORMS).map((form) => form.replace(/[()]/g, "\\$&")).join("|")})`, "g");
/** What stands in brackets is not read: the particle goes by the word before them. */
const REMARK = /\([^()]*\)$/;
const UNIT = /[0-9] ?(?:mm|cm|m|km|s|ms|h|mm\/s|m\/s|MB|GB|%)$/;
const DIGITS: Record<string, Sound> = { "0": "consonant", "1": "l", "3": "consonant", "6": "consonant", "7": "l", "8": "l" };
/** Letters whose Korean names end in a consonant: 엘, 엠, 엔, 알. */
const LETTERS: Record<string, Sound> = { L: "l", M: "consonant", N: "consonant", R: "l" };
const OPEN = new Set("aiouywrdgfvszxh");
/** Ends of words that are read as words; of others (port, map, node) letters alone do not tell. */
const SPOKEN: Record<string, Sound> = { l: "l", m: "consonant", n: "consonant" };
/** Capitals of so many letters, or without a vowel among them, are read letter by letter. */
const ABBREVIATION = 3;

/** A text with the particle that fits in each place where it can be told; elsewhere 이(가) stays as it is. */
export function settled(text: string): string {
  let done = "";
  let at = 0;
  for (const form of text.matchAll(FORM)) {
    const before = done + text.slice(at, form.index);
    const sound = soundOf(before);
    if (sound === null) continue;
    done = before + chosen(form[1] ?? "", sound);
    at = form.index + form[0].length;
  }
  return done + text.slice(at);
}

function chosen(form: string, sound: Sound): string {
  const [open, closed] = FORMS[form] ?? [form, form];
  return sound === "vowel" || (sound === "l" && form === "(으)로") ? open : closed;
}

/** How a text ends, read aloud in Korean; null: its letters do not tell. */
export function soundOf(given: string): Sound | null {
  let text = given.replace(/['"’”」`]+$/, "");
  for (;;) {
    const shorter = text.replace(REMARK, "").replace(/['"’”」` ]+$/, "");
    if (shorter === text || !shorter) break;
    text = shorter;
  }
  if (UNIT.test(text)) return "vowel";
  const last = text.slice(-1);
  if (last >= "가" && last <= "힣") return ofSyllable(last);
  if (/[0-9]/.test(last)) return DIGITS[last] ?? "vowel";
  const word = /[A-Za-z]*$/.exec(text)?.[0] ?? "";
  return word ? ofLetters(word) : null;
}

function ofSyllable(letter: string): Sound {
  const final = (letter.charCodeAt(0) - 0xac00) % 28;
  return final === 0 ? "vowel" : final === 8 ? "l" : "consonant";
}

function ofLetters(given: string): Sound | null {
  const capitals = given === given.toUpperCase();
  const byName = LETTERS[given.slice(-1).toUpperCase()] ?? "vowel";
  if (given.length === 1 || (capitals && (given.length <= ABBREVIATION || !/[AEIOUY]/.test(given)))) return byName;
  const word = given.toLowerCase();
  const last = word.slice(-1);
  const spoken = word.endsWith("ng") ? "consonant" : OPEN.has(last) ? "vowel" : (SPOKEN[last] ?? null);
  return capitals && spoken !== byName ? null : spoken;
}
