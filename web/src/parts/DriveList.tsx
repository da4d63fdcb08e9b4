/** Axis drives, each in one line: what it does, or what is wrong with it. */
import { hundredths, lookOfDrive } from "../shows";
import { driveList, selected } from "../store";
import { said, t, tell } from "../texts";
import type { Drive } from "../types";

export function DriveList() {
  return (
    <ul class="scroll machines">
      {driveList.value.map((drive) => (
        <Row key={drive.id} drive={drive} />
      ))}
    </ul>
  );
}

function Row({ drive }: { drive: Drive }) {
  const { word, tone } = lookOfDrive(drive);
  const chosen = selected.value?.kind === "drive" && selected.value.id === drive.id;
  const heard = drive.online === true;
  const why = drive.online ? said(drive.meaning) : tell(drive.reason);
  const choose = (): void => {
    selected.value = chosen ? null : { kind: "drive", id: drive.id };
  };
  return (
    <li>
      <button type="button" class="row drives" aria-pressed={chosen} data-drive={drive.id} onClick={choose}>
        <i class={`dot ${tone}`} />
        <b>{drive.id}</b>
        <span title={tell(drive.name)}>{tell(drive.name)}</span>
        <span class={tone}>{t(`drive_${word}`)}</span>
        <span class="number">{heard && drive.distance !== null ? hundredths(drive.distance) : ""}</span>
        <span class={tone === "bad" ? "more bad" : "more"} title={why}>
          {why}
        </span>
      </button>
    </li>
  );
}
