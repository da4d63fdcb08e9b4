"""What people do at the page, where it takes more than a click."""

from playwright.sync_api import Locator, Page

TWICE = """async (button) => {
  const armed = () => button.classList.contains("armed");
  const idle = () => button.disabled || button.ariaDisabled === "true";
  for (let frame = 0; idle() && frame < 1000; frame++) await new Promise(requestAnimationFrame);
  if (!armed()) button.click();
  for (let frame = 0; !armed() && frame < 1000; frame++) await new Promise(requestAnimationFrame);
  if (!armed()) throw new Error("the button does not ask whether one is sure");
  button.click();
}"""
"""Presses a button that wants to be pressed twice. It forgets the first press after some seconds, which a machine with
more to do may let pass between two words from outside the page. What was just written into a field enables it a frame later."""


def press_twice(scope: Locator | Page, name: str) -> None:
    """Press a button that asks whether one is sure, and say so."""
    button = scope.get_by_role("button", name=name, exact=True)
    button.click(trial=True)
    button.evaluate(TWICE)
