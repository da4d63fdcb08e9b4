import { room } from "../route";
import { asked } from "../access";
import { away } from "../known";
import { controller, inPast, selected } from "../store";
import { t, tell } from "../texts";
import { Alarms } from "./Alarms";
import { Audit } from "./Audit";
import { Away } from "./Away";
import { Barred } from "./Barred";
import { Below } from "./Below";
import { Closures } from "./Closures";
import { DevicePanel } from "./DevicePanel";
import { DrivePanel } from "./DrivePanel";
import { Header, Rooms } from "./Header";
import { JobPanel } from "./JobPanel";
import { JobRoom } from "./JobRoom";
import { Jobs } from "./Jobs";
import { Layouts } from "./Layouts";
import { LogIn } from "./LogIn";
import { CloseOrder, OpenOrder, ordering } from "./Ordering";
import { PastPanel } from "./PastPanels";
import { PastEvents, Playback } from "./Playback";
import { StationPanel } from "./StationPanel";
import { Staff } from "./Staff";
import { Stations } from "./Stations";
import { Statistics } from "./Statistics";
import { Teaching } from "./Teaching";
import { TrackMap } from "./TrackMap";
import { Transfer } from "./Transfer";
import { VehiclePanel } from "./VehiclePanel";
import { Vehicles } from "./Vehicles";
import { VehicleStrip } from "./VehicleStrip";
import { Walks } from "./Walks";
import { Webhooks } from "./Webhooks";

export function App() {
  const pick = selected.value;
  if (inPast.value || room.value === "playback") return <Past />;
  return (
    <div class={away.value ? "page old" : "page"}>
      <Header />
      <div>
        <div class="top">
          <Rooms />
          <OpenOrder />
        </div>
        <Away />
      </div>
      <main>
        <section class="left">{room.value === "map" ? <Plan /> : <Room />}</section>
        <aside id="ordering" class={pick ? (room.value === "map" ? "telling" : "telling alone") : room.value === "map" ? "" : ordering.value ? "spare open" : "spare"}>
          <CloseOrder />
          <Transfer />
          {pick?.kind === "vehicle" && <VehiclePanel key={pick.id} id={pick.id} />}
          {pick?.kind === "station" && <StationPanel key={pick.id} id={pick.id} />}
          {pick?.kind === "device" && <DevicePanel key={pick.id} id={pick.id} />}
          {pick?.kind === "drive" && <DrivePanel key={pick.id} id={pick.id} />}
          {pick?.kind === "job" && <JobPanel key={pick.id} id={pick.id} />}
          <Jobs />
        </aside>
      </main>
      {asked.value && <LogIn />}
      <Barred />
    </div>
  );
}

/** What was: nothing on it can be commanded. */
function Past() {
  const pick = selected.value;
  return (
    <div class="page past">
      <Header />
      <Rooms />
      <main>
        <section class="left">
          <Playback />
        </section>
        <aside class={pick ? "telling" : ""}>
          {pick && <PastPanel key={`${pick.kind} ${pick.id}`} pick={pick} />}
          <PastEvents />
          <Jobs />
        </aside>
      </main>
      {asked.value && <LogIn />}
      <Barred />
    </div>
  );
}

function Plan() {
  return (
    <div class="plan">
      <VehicleStrip />
      <div class="stage">
        <Circles />
        <TrackMap />
      </div>
      <Below />
    </div>
  );
}

/** Closing track is best done on the map. */
function Closing() {
  return (
    <div class="plan closing">
      <div class="stage">
        <Circles />
        <TrackMap />
      </div>
      <Closures />
    </div>
  );
}

/** Hoists that wait for each other: nothing else matters as much. */
function Circles() {
  const now = controller.value;
  if (!now?.circles?.length) return null;
  return (
    <div class="banner" role="alert">
      <b>{t("circle")}</b>
      <span>{now.circles.map(tell).join(" · ")}</span>
      <small class="calm">{t("circles_counted", now.circles_found, now.circles_resolved)}</small>
    </div>
  );
}

function Room() {
  switch (room.value) {
    case "vehicles":
      return <Vehicles />;
    case "jobs":
      return <JobRoom />;
    case "alarms":
      return <Alarms />;
    case "closures":
      return <Closing />;
    case "stations":
      return <Stations />;
    case "walks":
      return <Walks />;
    case "access":
      return <Staff />;
    case "webhooks":
      return <Webhooks />;
    case "audit":
      return <Audit />;
    case "teaching":
      return <Teaching />;
    case "statistics":
      return <Statistics />;
    case "layouts":
      return <Layouts />;
    default:
      return null;
  }
}
