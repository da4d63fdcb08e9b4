"""An MES in small: orders transfers, follows them to their end, and after any break knows again where each one is.

    pip install ./clients/python        # or PYTHONPATH=clients/python
    python examples/python/mes.py http://127.0.0.1:8080 mes-state.json LOT-1:ETCH01-P1:SBB-R4 [...]

What has to survive a crash of the MES is in one file: the orders, and the number of the last event dealt with. Every order has an
id of its own, so that it may be sent again without thinking: the same id is the same job. On standard output are the events, and
at the end how each order ended; on standard error is what the controller says of orders that it refuses, or that wait. It exits
with 0 if all were completed.
"""

import argparse
import json
import os
import sys
import threading
from pathlib import Path
from typing import Any

from hoistway_client import Hoistway, Problem, Unreachable

LOOK_EVERY = 2.0
"""Seconds between two looks at why orders wait: no event tells of that."""
NOT_OF_THE_ORDER = {401, 403, 408, 429}
"""Refusals of whoever asks, or of when: the order itself may be right, and is sent again next time."""
FORM = "NAME:SOURCE:DESTINATION"
ENDED = {"completed", "failed", "cancelled", "aborted"}
ENDS = {"TransferCompleted", "TransferCancelCompleted", "TransferAbortCompleted"}


class Mes:
    """Orders and what became of them; ``after`` is the number of the last event dealt with."""

    def __init__(self, file: Path) -> None:
        self.file = file
        kept: dict[str, Any] = json.loads(file.read_text(encoding="utf-8")) if file.exists() else {}
        self.orders: dict[str, dict[str, str]] = kept.get("orders", {})
        self.after: int | None = kept.get("after")

    def save(self) -> None:
        """Keep it, whole or not at all."""
        beside = self.file.with_suffix(".new")
        beside.write_text(json.dumps({"orders": self.orders, "after": self.after}, indent=1), encoding="utf-8")
        beside.replace(self.file)

    @property
    def open(self) -> list[str]:
        """Orders that have not ended, as far as is known."""
        return [name for name, order in self.orders.items() if order.get("state") not in ENDED]

    def reconcile(self, hoistway: Hoistway) -> None:
        """Before anything else: where do events begin, which orders never arrived, and what has become of the others?"""
        if self.after is None:
            self.after = 0
        for name in self.open:
            try:
                job = hoistway.get_job(name)
            except Problem as problem:
                if problem.code != "not-found":
                    raise
                self.post(hoistway, name)
            else:
                self.orders[name]["state"] = job["state"]
        self.save()

    def post(self, hoistway: Hoistway, name: str) -> None:
        """Send an order; the same again gives the same job."""
        order = self.orders[name]
        try:
            job = hoistway.create_job({"job_id": name, "source": order["source"], "destination": order["destination"]})
            order["state"] = job["state"]
        except Problem as problem:
            if problem.status >= 500 or problem.status in NOT_OF_THE_ORDER:
                raise
            order.update(state="failed", why=str(problem))
            tell(f"{name} is refused: {problem}")
        self.save()

    def follow(self, hoistway: Hoistway) -> None:
        """Deal with events until every order has ended; a lost connection goes on where it was."""
        for event in hoistway.events(self.after):
            name = event["job"]
            if name in self.orders:
                print(event["seq"], event["event"], name, event["vehicle"] or "", event["result"], flush=True)  # noqa: T201
                if event["event"] in ENDS:
                    self.orders[name].update(state=event["result"], why=event["detail"])
            self.after = event["seq"]
            self.save()
            if not self.open:
                return

    def watch(self, hoistway: Hoistway, ended: threading.Event) -> None:
        """Say why orders wait, each time that the controller gives another reason, until all have ended."""
        told: dict[str, str] = {}
        while True:
            for name in self.open:
                try:
                    job = hoistway.get_job(name)
                except (Problem, Unreachable):
                    continue  # following the events, one waits until the controller is there again
                if job["reason"] and job["reason"] != told.get(name):
                    tell(f"{name} is {job['state']}: {job['reason']}")
                told[name] = job["reason"]
            if ended.wait(LOOK_EVERY):
                return


def tell(text: str) -> None:
    """Say something to whoever started the program."""
    print(text, file=sys.stderr, flush=True)  # noqa: T201


def an_order(text: str) -> tuple[str, dict[str, str]]:
    """Return the name of an order, and its ends. Raises argparse.ArgumentTypeError."""
    parts = text.split(":")
    if len(parts) != 3 or not all(parts):
        raise argparse.ArgumentTypeError(f"{text!r} is no order: write {FORM}, as LOT-1:ETCH01-P1:SBB-R4")
    return parts[0], {"source": parts[1], "destination": parts[2]}


def asked() -> argparse.ArgumentParser:
    """Return what reads the command line."""
    parser = argparse.ArgumentParser(description="Order transfers, and follow them to their end, through any break.")
    parser.add_argument("url", help="where the controller is: http://127.0.0.1:8080 (its key, if any: HOISTWAY_KEY)")
    parser.add_argument(
        "file", type=Path, help="where the orders are kept, and the last event (made if it is not there)"
    )
    parser.add_argument("orders", type=an_order, nargs="*", default=[], metavar=FORM, help="a transfer to order")
    return parser


def see_to_the_end(mes: Mes, hoistway: Hoistway) -> None:
    """Send what has not arrived, and follow all orders to their end. Raises Problem, Unreachable."""
    mes.reconcile(hoistway)
    ended = threading.Event()
    watching = threading.Thread(target=mes.watch, args=(hoistway, ended))
    watching.start()
    try:
        if mes.open:
            mes.follow(hoistway)
    finally:
        ended.set()
        watching.join()


def main() -> None:
    """Take the orders of the command line, and see all of them to their end."""
    parser = asked()
    given = parser.parse_args()
    try:
        mes = Mes(given.file)
        for name, order in given.orders:
            kept = mes.orders.setdefault(name, order)
            if any(kept[end] != order[end] for end in order):
                parser.error(f"{name} was ordered already, from {kept['source']} to {kept['destination']}")
        mes.save()
        with Hoistway(given.url, key=os.environ.get("HOISTWAY_KEY"), actor="mes") as hoistway:
            see_to_the_end(mes, hoistway)
    except (OSError, ValueError) as wrong:
        parser.exit(1, f"{parser.prog}: {given.file} cannot be used: {wrong}\n")
    except (Problem, Unreachable) as wrong:
        parser.exit(1, f"{parser.prog}: {wrong}\nWhat was ordered is kept in {given.file}: start it again.\n")
    except KeyboardInterrupt:
        parser.exit(130, f"{parser.prog}: what was ordered is kept in {given.file}: start it again.\n")
    print(json.dumps({name: order.get("state") for name, order in mes.orders.items()}))  # noqa: T201
    sys.exit(0 if all(order.get("state") == "completed" for order in mes.orders.values()) else 1)


if __name__ == "__main__":
    main()
