"""The words of the business: units, ids, layout, vehicles, jobs, commands, events, errors. Standard library only."""
