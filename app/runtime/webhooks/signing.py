"""Signatures by the Standard Webhooks specification 1.0: HMAC-SHA256 over ``id.timestamp.body``, several side by side."""

import base64
import hmac
from collections.abc import Iterable
from hashlib import sha256

PREFIX = "whsec_"
SECRET_BYTES = 32


def drawn_secret(draw: bytes) -> str:
    """Return a secret as receivers write it down, from random bytes (24 to 64)."""
    return PREFIX + base64.b64encode(draw).decode()


def signature(secrets: Iterable[str], name: str, timestamp: int, body: bytes) -> str:
    """Return the header ``webhook-signature``: one signature a secret, with a blank between."""
    signed = b"%b.%d.%b" % (name.encode(), timestamp, body)
    return " ".join("v1," + base64.b64encode(hmac.digest(_key(secret), signed, sha256)).decode() for secret in secrets)


def _key(secret: str) -> bytes:
    return base64.b64decode(secret.removeprefix(PREFIX))
