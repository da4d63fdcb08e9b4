import { createHash } from "node:crypto";
import { readFileSync, readdirSync, rmSync, statSync, writeFileSync } from "node:fs";
import { join, posix } from "node:path";
import { defineConfig } from "vitest/config";
import type { Plugin } from "vite";

const ROOT = import.meta.dirname;
const BUNDLE = join(ROOT, "..", "app", "web");
/** What the bundle is made from; tests/web computes the same digest. */
const SOURCES = [
  "index.html",
  "package.json",
  "package-lock.json",
  "tsconfig.json",
  "vite.config.ts",
  "src",
  "../app/texts/en.json",
  "../app/texts/ko.json",
];

function filesOf(path: string): string[] {
  if (!statSync(join(ROOT, path)).isDirectory()) return [path];
  return readdirSync(join(ROOT, path)).flatMap((name) => filesOf(posix.join(path, name)));
}

function digestOfSources(): string {
  const digest = createHash("sha256");
  for (const path of SOURCES.flatMap(filesOf).sort()) {
    digest.update(path).update("\0").update(readFileSync(join(ROOT, path))).update("\0");
  }
  return digest.digest("hex");
}

/** Clears the old assets, and writes beside the bundle what it was made from. */
function manifest(): Plugin {
  return {
    name: "manifest",
    apply: "build",
    // Notices in comments of libraries keep their names, but the page names no other host.
    renderChunk: (code) => code.replaceAll("https://github.com/", "github.com/"),
    buildStart() {
      rmSync(join(BUNDLE, "assets"), { recursive: true, force: true });
    },
    closeBundle() {
      writeFileSync(join(BUNDLE, "manifest.json"), `${JSON.stringify({ sources: digestOfSources() })}\n`);
    },
  };
}

export default defineConfig({
  root: ROOT,
  plugins: [manifest()],
  build: { outDir: BUNDLE, emptyOutDir: false, target: "es2022", minify: false, modulePreload: false, chunkSizeWarningLimit: 900 },
  server: { fs: { allow: [".."] }, proxy: { "/api": { target: "http://127.0.0.1:8080", ws: true }, "/healthz": "http://127.0.0.1:8080" } },
  test: { include: ["test/**/*.test.ts"] },
});
