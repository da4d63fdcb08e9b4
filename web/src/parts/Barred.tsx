/** Says over the page why a button does nothing for who is here, until it is put away. */
import { asked, barred } from "../access";
import { t } from "../texts";

export function Barred() {
  return (
    <div class="toast-place" role="status">
      {barred.value && (
        <div class="toast">
          <span>{barred.value}</span>
          <button
            type="button"
            onClick={() => {
              barred.value = "";
              asked.value = true;
            }}
          >
            {t("log_in_as_other")}
          </button>
          <button type="button" class="plain" aria-label={t("close")} onClick={() => (barred.value = "")}>
            ✕
          </button>
        </div>
      )}
    </div>
  );
}
