/** Says over the page why a button does nothing, for who is here or as things are, until it is put away. */
import { asked, barred } from "../access";
import { t } from "../texts";

export function Barred() {
  const now = barred.value;
  return (
    <div class="toast-place" role="status">
      {now && (
        <div class="toast">
          <span>{now.why}</span>
          {now.by === "role" && (
            <button
              type="button"
              onClick={() => {
                barred.value = null;
                asked.value = true;
              }}
            >
              {t("log_in_as_other")}
            </button>
          )}
          <button type="button" class="plain" aria-label={t("close")} onClick={() => (barred.value = null)}>
            ✕
          </button>
        </div>
      )}
    </div>
  );
}

document.addEventListener("keydown", (event) => {
  if (event.key === "Escape") barred.value = null;
});
