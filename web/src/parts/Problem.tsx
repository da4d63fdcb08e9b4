import { Refused } from "../api";
import { tell } from "../texts";

/** What the server said, and what would help. */
export function Problem({ error }: { error: unknown }) {
  if (!error) return null;
  const message = error instanceof Error ? error.message : String(error);
  const remedy = error instanceof Refused ? error.remedy : "";
  return (
    <div class="problem" role="alert">
      <b>{tell(message)}</b>
      {remedy && <span>{tell(remedy)}</span>}
    </div>
  );
}
