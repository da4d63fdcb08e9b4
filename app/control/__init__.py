"""The whole controller as one sans-I/O object: sessions and Fleet, one transaction after the other."""

from app.control.control import Control, Transaction

__all__ = ["Control", "Transaction"]
