"""An MES in small: orders transfers, follows them to their end, and after any break knows again where each one is.

    pip install ./clients/python        # or PYTHONPATH=clients/python
    python examples/python/mes.py http://127.0.0.1:8080 mes-state.json LOT-1:ETCH01-P1:SBB-R4 [...]

What has to survive a crash of the MES is in one file: the orders, and the number of the last event dealt with. Every order has an
id of its own, so that it may be sent again without thinking: the same id is the same job.
"""

import json
import os
import sys
from pathlib import Path
from typing import Any

from hoistway_client import Hoistway, Problem

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
            if problem.status >= 500:
                raise
            order.update(state="failed", why=str(problem))
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


def main() -> None:
    """Take the orders of the command line, and see all of them to their end."""
    url, file, *orders = sys.argv[1:]
    mes = Mes(Path(file))
    for text in orders:
        name, source, destination = text.split(":")
        mes.orders.setdefault(name, {"source": source, "destination": destination})
    mes.save()
    with Hoistway(url, key=os.environ.get("HOISTWAY_KEY"), actor="mes") as hoistway:
        mes.reconcile(hoistway)
        if mes.open:
            mes.follow(hoistway)
    print(json.dumps({name: order.get("state") for name, order in mes.orders.items()}))  # noqa: T201


if __name__ == "__main__":
    main()
