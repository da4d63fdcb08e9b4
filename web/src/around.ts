/** What stands against a request, in the words of who reads it; of what the page knows now. */
import { type Against, type Around } from "./against";
import { changes, closures, controller, layout, vehicles } from "./store";
import { t, type Word } from "./texts";

/** What a request depends on besides what it is about. */
export function around(): Around {
  void changes.closures.value;
  return { controller: controller.value, closures: closures.values(), layout: layout.value, vehicles: vehicles.values() };
}

/** What a button is told: why the controller would refuse it; nothing where nothing speaks against it. */
export function stopped(against: Against): { against?: string } {
  return against ? { against: inWords(against) } : {};
}

export function inWords(against: NonNullable<Against>): string {
  const [word, ...values] = against;
  return t(word as Word, ...values);
}
