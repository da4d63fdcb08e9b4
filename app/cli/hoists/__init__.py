"""``hoistway bench hoists``: one controller process, and hoists simulated to the byte in other processes.

``run`` starts and reports, ``controller`` and ``floor`` are the children, ``load`` is the host that orders, ``sampling`` tells
what a process spends its time on.
"""
