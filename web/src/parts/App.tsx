import { keyWanted, selected } from "../store";
import { Below } from "./Below";
import { DevicePanel } from "./DevicePanel";
import { DrivePanel } from "./DrivePanel";
import { Header } from "./Header";
import { Jobs } from "./Jobs";
import { KeyPrompt } from "./KeyPrompt";
import { StationPanel } from "./StationPanel";
import { TrackMap } from "./TrackMap";
import { Transfer } from "./Transfer";
import { VehiclePanel } from "./VehiclePanel";
import { VehicleStrip } from "./VehicleStrip";

export function App() {
  const pick = selected.value;
  return (
    <div class="page">
      <Header />
      <main>
        <section class="left">
          <VehicleStrip />
          <div class="stage">
            <TrackMap />
          </div>
          <Below />
        </section>
        <aside class={pick ? "telling" : ""}>
          <Transfer />
          {pick?.kind === "vehicle" && <VehiclePanel key={pick.id} id={pick.id} />}
          {pick?.kind === "station" && <StationPanel key={pick.id} id={pick.id} />}
          {pick?.kind === "device" && <DevicePanel key={pick.id} id={pick.id} />}
          {pick?.kind === "drive" && <DrivePanel key={pick.id} id={pick.id} />}
          <Jobs />
        </aside>
      </main>
      {keyWanted.value && <KeyPrompt />}
    </div>
  );
}
