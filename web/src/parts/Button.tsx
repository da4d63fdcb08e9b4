/**
 * A button that asks the server for something. Whoever may not press it, or presses it when the controller would refuse that, is
 * told so: by its look, its title, and when it is pressed. It can be reached by keyboard, and keeps the focus when that changes.
 */
import type { ComponentProps } from "preact";
import { barred, type Call, refusal } from "../access";

type Props = Omit<ComponentProps<"button">, "class"> & {
  needs: Call;
  class?: string;
  /** Why the controller would refuse it now. */
  against?: string | undefined;
};

export function Button({ needs, class: looks = "", against, disabled, onClick, title, type = "button", ...rest }: Props) {
  const role = refusal(needs);
  const why = role || against;
  if (!why && !disabled) {
    const press = (event: never): void => {
      barred.value = null;
      (onClick as ((event: never) => void) | undefined)?.(event);
    };
    return <button {...({ ...rest, title, onClick: press } as object)} type={type} class={looks} data-needs={needs} />;
  }
  const tell = (event: Event): void => {
    event.preventDefault();
    if (why) barred.value = { why, by: role ? "role" : "state" };
  };
  // A held key or a press must not do what a click does not.
  const others = Object.fromEntries(Object.entries(rest).filter(([name]) => !/^on[A-Z]/.test(name)));
  return (
    <button {...(others as object)} type={type} class={`${looks} ${role ? "barred" : "stopped"}`} data-needs={needs} title={why || title} aria-disabled onClick={tell} />
  );
}
