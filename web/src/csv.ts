/** Tables as files, and back: RFC 4180. */

type Cell = string | number | boolean | null | undefined;

/** What a spreadsheet would take for a formula stands behind an apostrophe: names and reasons come from anybody. */
function cell(value: Cell): string {
  if (value === null || value === undefined) return "";
  const text = typeof value === "string" && /^[=+\-@\t\r]/.test(value) ? `'${value}` : String(value);
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

/** Rows under the names of their columns. The mark at the beginning tells spreadsheets that it is UTF-8. */
export function csvOf<T extends object>(columns: (keyof T & string)[], rows: T[]): string {
  const lines = rows.map((row) => columns.map((name) => cell(row[name] as Cell)).join(","));
  return `\ufeff${[columns.join(","), ...lines].join("\r\n")}\r\n`;
}

/** Rows by the names in the first line, in lower case; blank lines are left out. Raises Error: a quotation mark too few. */
export function rowsOf(text: string): Record<string, string>[] {
  const lines = table(text.replace(/^\ufeff/, "")).filter((line) => line.some((one) => one.trim() !== ""));
  const names = (lines.shift() ?? []).map((name) => name.trim().toLowerCase());
  return lines.map((line) => Object.fromEntries(names.map((name, i) => [name, (line[i] ?? "").trim().replace(/^'(?=[=+\-@])/, "")])));
}

function table(text: string): string[][] {
  // A semicolon parts columns where spreadsheets write decimals with a comma.
  const first = text.slice(0, text.search(/\r|\n|$/));
  const part = first.includes(";") && !first.includes(",") ? ";" : ",";
  const lines: string[][] = [[]];
  let [value, quoted] = ["", false];
  const end = (): void => {
    lines.at(-1)?.push(value);
    value = "";
  };
  for (let i = 0; i < text.length; i++) {
    const sign = text[i] as string;
    if (quoted && sign === '"' && text[i + 1] === '"') value += text[++i];
    else if (sign === '"') quoted = !quoted;
    else if (!quoted && sign === part) end();
    else if (!quoted && (sign === "\n" || sign === "\r")) {
      if (sign === "\r" && text[i + 1] === "\n") i++;
      end();
      lines.push([]);
    } else value += sign;
  }
  if (quoted) throw new Error("a quotation mark is never closed");
  end();
  return lines;
}

/** Let the browser save a text. */
export function save(text: string, name: string, kind = "text/csv"): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type: `${kind};charset=utf-8` }));
  link.download = name;
  link.click();
  URL.revokeObjectURL(link.href);
}
