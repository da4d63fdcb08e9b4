"""What can be set on a simulated vehicle: every figure that PROTOCOLS 5.1 gives as a default."""

from dataclasses import dataclass
from enum import StrEnum

from app.domain.units import Pulses, Seconds


class RespTiming(StrEnum):
    """When RESP1 of an accepted command is sent (I19)."""

    COMPLETION = "completion"
    ACCEPTANCE = "acceptance"


@dataclass(frozen=True, slots=True)
class Options:
    """Times in seconds; the defaults are PROTOCOLS 5.1's unless marked as our choice. Speeds are the vehicle's own."""

    ack_delay: Seconds = Seconds(0.005)
    """From a packet's last byte to its ACK; what it asks for is begun at the same moment."""
    resend_after: Seconds = Seconds(1.0)
    resends: int = 3
    """How often an unacknowledged packet is sent again (5.1, rule 7; I21)."""
    remembered: int = 64
    """CMD_IDs kept for recognising a command sent twice (I23)."""
    resp_timing: RespTiming = RespTiming.COMPLETION
    send_nak: bool = False
    """Answer a packet with a bad CRC by NAK, where its ids can be read (I17)."""
    alarm_events: bool = False
    """Send STATUS when OPER changes too; the source does not (1.10)."""
    stop_tag_only: bool = False
    """Firmware of document B: TRAV 1 at any stop position (1.8)."""
    rota_servo_codes: bool = False
    """Firmware of document B: ROTA shows 11 while the servos are off (1.8)."""
    flush_after: Seconds = Seconds(0.2)
    """Silence after which an incomplete packet is given up (6.1)."""
    servo_time: Seconds = Seconds(0.5)
    search_home_time: Seconds = Seconds(2.0)
    go_home_time: Seconds = Seconds(1.0)
    step_time: Seconds = Seconds(0.5)
    """Each step of PICKUP and PLACE."""
    close_after_reset: Seconds = Seconds(0.1)
    reboot_time: Seconds = Seconds(3.0)
    """How long connections are refused after a SYSTEM RESET or a power cycle."""
    process_code: int = 0x2100
    """CODE while a MOVE runs (I30)."""
    wrong_barcode_alarm: int = 101
    no_foup_alarm: int = 201
    foup_lost_alarm: int = 202
    place_taken_alarm: int = 203
    """PLACE found the place occupied. Our choice."""
    buffer_lift: Pulses = Pulses(400_000)
    """LIFT at a side buffer, which the vehicle knows itself. Our choice."""
    switch_reach: float = 500.0
    """How far past a barcode, in mm, a running vehicle can still be sent into another branch by XMOVE. Our choice."""
