/** A button that asks the server for something: whoever may not press it is told so, by its look, its title, and when it is pressed. */
import type { ComponentProps } from "preact";
import { barred, type Call, refusal } from "../access";

type Props = Omit<ComponentProps<"button">, "class"> & { needs: Call; class?: string };

export function Button({ needs, class: looks = "", onClick, title, type = "button", ...rest }: Props) {
  const why = refusal(needs);
  if (!why) return <button {...({ ...rest, title, onClick } as object)} type={type} class={looks} data-needs={needs} />;
  const tell = (event: Event): void => {
    event.preventDefault();
    barred.value = why;
  };
  const { disabled: _, ...others } = rest;
  return <button {...(others as object)} type={type} class={`${looks} barred`} data-needs={needs} title={why} aria-disabled onClick={tell} />;
}
