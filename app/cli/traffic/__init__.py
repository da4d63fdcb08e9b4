"""``hoistway bench traffic``: what the rules of traffic are worth on a whole fab, in the fast plant."""
