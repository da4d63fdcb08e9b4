"""REST and WebSocket: what people, hosts and the page ask of the controller, under ``/api/v1``."""

from app.api.application import application

__all__ = ["application"]
