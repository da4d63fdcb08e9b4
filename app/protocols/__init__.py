"""One folder for each protocol; they know nothing of each other."""
