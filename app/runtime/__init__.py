"""The asyncio shell around the controller."""
