/** The name of something, which chooses it: of whatever kind there is one of that name. */
import { devices, drives, jobs, selected, stations, vehicles } from "../store";

export function Name({ id }: { id: string | null }) {
  if (!id) return null;
  const kind = vehicles.has(id)
    ? "vehicle"
    : stations.has(id)
      ? "station"
      : devices.has(id)
        ? "device"
        : drives.has(id)
          ? "drive"
          : jobs.has(id)
            ? "job"
            : null;
  if (!kind) return <>{id}</>;
  return (
    <button type="button" class="text" onClick={() => (selected.value = { kind, id })}>
      {id}
    </button>
  );
}
