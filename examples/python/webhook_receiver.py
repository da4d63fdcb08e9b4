"""A receiver of Hoistway's webhooks with the standard library alone: checks the signature, takes each event once.

HOISTWAY_WEBHOOK_SECRET=whsec_... python webhook_receiver.py 9000
"""

import base64
import hmac
import json
import os
import sys
import time
from collections.abc import Mapping
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer

TOLERANCE = 300
"""Seconds that a message may be old: an older one may be a recording that somebody plays again."""


def genuine(secret: str, headers: Mapping[str, str], body: bytes, now: float) -> bool:
    """Return whether a message was signed with the secret, lately (Standard Webhooks)."""
    name, timestamp = headers.get("webhook-id", ""), headers.get("webhook-timestamp", "")
    if not timestamp.isdigit() or abs(now - int(timestamp)) > TOLERANCE:
        return False
    key = base64.b64decode(secret.removeprefix("whsec_"))
    expected = hmac.digest(key, f"{name}.{timestamp}.".encode() + body, "sha256")
    given = [one.partition(",")[2] for one in headers.get("webhook-signature", "").split() if one.startswith("v1,")]
    return any(hmac.compare_digest(base64.b64encode(expected).decode(), one) for one in given)


class Receiver(BaseHTTPRequestHandler):
    """Answers 204 once a message is dealt with. Anything else, or no answer, and it comes again."""

    secret = ""
    seen: set[str] = set()
    """Ids of messages that were dealt with. A real receiver keeps them where its data is, in the same transaction."""

    def do_POST(self) -> None:
        """Take one message."""
        body = self.rfile.read(int(self.headers.get("Content-Length", "0")))
        if not genuine(self.secret, {name.lower(): value for name, value in self.headers.items()}, body, time.time()):
            self.send_error(401)
            return
        name = self.headers["webhook-id"]
        if name not in self.seen:
            deal_with(json.loads(body))
            self.seen.add(name)
        self.send_response(204)
        self.end_headers()

    def log_message(self, format: str, *args: object) -> None:  # noqa: A002
        """Say nothing of each request."""


def deal_with(message: Mapping[str, object]) -> None:
    """Do what there is to do: here, print a line."""
    print(json.dumps(message), flush=True)  # noqa: T201


def main() -> None:
    """Serve until Ctrl-C."""
    Receiver.secret = os.environ["HOISTWAY_WEBHOOK_SECRET"]
    with ThreadingHTTPServer(("127.0.0.1", int(sys.argv[1])), Receiver) as server:
        server.serve_forever()


if __name__ == "__main__":
    main()
