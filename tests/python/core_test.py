"""The protocol core without a network: what a server may send, and what no server sends."""

import random
import re

import pytest

import amalgam
import support
from amalgam import conversation as core
from amalgam import limits
from amalgam.amalgam_pb2 import Busy, Draining, Envelope, Error, Ping
from amalgam.errors import CLOSING, REJECTING
from amalgam.framing import Decoder, encode


def running():
    conversation = core.Conversation(core.make_hello(support.CAMERA, "", 0, None))
    conversation.take_output()
    events = conversation.receive(support.welcome(), 0)
    assert [type(e) for e in events] == [core.Welcomed]
    return conversation


def send(conversation, capture_time_us=0, poses=()):
    return conversation.send_frame(support.plain_jpeg(), poses, (), capture_time_us)


def examples():
    """The byte examples of PROTOCOL.md, by message."""
    text = (support.SOURCE / "protocol/PROTOCOL.md").read_text()
    return {name: bytes.fromhex(hexes) for name, hexes in re.findall(r"```hex (\w+)\n(.*?)```", text, re.S)}


FROM_SERVERS = ("Welcome", "Composite", "Ping", "Pong", "Busy", "Error", "Draining")


def test_the_documents_examples_arrive_in_any_pieces():
    everything = b"".join(examples()[name] for name in FROM_SERVERS)
    for size in range(1, len(everything) + 1):
        decoder = Decoder()
        bodies = [e.WhichOneof("body") for at in range(0, len(everything), size)
                  for e in decoder.feed(everything[at : at + size])]
        assert bodies == [name.lower() for name in FROM_SERVERS]
        assert decoder.buffered == 0


def test_the_hello_is_the_documents():
    camera = amalgam.Camera(640, 480, 600, 600, 319.5, 239.5)
    conversation = core.Conversation(core.make_hello(camera, "opensesame", 85, None))
    assert conversation.take_output() == examples()["Hello"]


def test_limits_are_those_of_the_server():
    header = (support.SOURCE / "protocol/limits.h").read_text()
    constants = {name: eval(value) for name, value in
                 re.findall(r"(k\w+) = ([\d *e]+);", header)}
    times = {name: int(ms) for name, ms in re.findall(r"milliseconds (k\w+)\{(\d+)\}", header)}
    for name in ("PROTOCOL_VERSION", "LENGTH_BYTES", "MAX_CONTROL_BYTES", "MAX_CAMERA_FRAME_BYTES",
                 "MAX_COMPOSITE_BYTES", "MAX_TOKEN_BYTES", "MAX_SIDE", "MAX_POSES", "MAX_DISTORTION",
                 "MAX_JPEG_QUALITY", "MAX_BEFORE_HELLO_BYTES", "MAX_SMOOTHING"):
        assert getattr(limits, name) == constants["k" + name.title().replace("_", "")], name
    assert limits.IDLE_TIMEOUT * 1000 == times["kIdleTimeout"]
    assert limits.LINGER * 1000 == times["kLinger"]


def test_every_error_code_has_an_exception():
    codes = set(Error.Code.keys()) - {"UNSPECIFIED", "BAD_ENVIRONMENT"}
    assert codes == set(CLOSING) | set(REJECTING)
    text = (support.SOURCE / "protocol/PROTOCOL.md").read_text()
    closes = dict(re.findall(r"^\| \d+ \| `(\w+)` \| (yes|no) \|", text, re.M))
    for code in codes:
        conversation = running()
        frame = send(conversation)
        (event,) = conversation.receive(support.error(code, frame, closes[code] == "yes"), 0)
        assert isinstance(event, core.Ended if closes[code] == "yes" else core.Rejected), code
        assert type(event.error) is {**CLOSING, **REJECTING}[code]
        assert (conversation.state is core.State.ENDED) == (closes[code] == "yes")


@pytest.mark.parametrize("name", FROM_SERVERS)
def test_each_cut_is_waited_for_or_refused(name):
    message = examples()[name]
    body = message[limits.LENGTH_BYTES :]
    for cut in range(1, len(body)):
        decoder = Decoder()
        assert list(decoder.feed(message[: limits.LENGTH_BYTES + cut])) == []
        # The length says that it is whole, and it is not: its one field ends before its end.
        with pytest.raises(amalgam.ProtocolViolation):
            list(Decoder().feed(cut.to_bytes(4, "little") + body[:cut]))


@pytest.mark.parametrize("head, why", [
    (b"\x00\x00\x00\x00", "no bytes"),
    ((limits.MAX_COMPOSITE_BYTES + 1).to_bytes(4, "little") + b"\x42", "at most"),
    ((limits.MAX_CONTROL_BYTES + 1).to_bytes(4, "little") + b"\x3a", "at most"),
    (b"\xff\xff\xff\xff\x42", "at most"),
    (b"\x02\x00\x00\x00\x62", "unknown kind"),  # body 12
    (b"\x02\x00\x00\x00\x08", "unknown kind"),  # a number in place of a message
])
def test_a_bad_head_is_refused_before_the_rest_comes(head, why):
    conversation = running()
    (event,) = conversation.receive(head, 0)
    assert isinstance(event.error, amalgam.ProtocolViolation) and why in str(event.error)
    with pytest.raises(amalgam.ProtocolViolation):
        send(conversation)
    assert conversation.receive(support.welcome(), 0) == []


def test_largest_composite_is_waited_for():
    decoder = Decoder()
    assert list(decoder.feed(limits.MAX_COMPOSITE_BYTES.to_bytes(4, "little") + b"\x42")) == []


def test_two_bodies_are_refused_and_unknown_fields_are_not():
    ping, pong = b"\x22\x02\x08\x03", b"\x2a\x02\x08\x03"
    for second in (ping, pong):
        (event,) = running().receive((8).to_bytes(4, "little") + ping + second, 0)
        assert isinstance(event.error, amalgam.ProtocolViolation)
    unknown = b"\xa2\x01\x01x"  # field 20
    conversation = running()
    assert conversation.receive((8).to_bytes(4, "little") + ping + unknown, 0) == []
    assert conversation.take_output() == encode(Envelope(pong={"nonce": 3}))


# Some versions of protobuf warn as well.
@pytest.mark.filterwarnings("ignore:Unexpected end-group tag")
def test_a_stray_end_of_a_group_is_refused():
    (event,) = running().receive((3).to_bytes(4, "little") + b"\x22\x01\x0c", 0)
    assert isinstance(event.error, amalgam.ProtocolViolation)


@pytest.mark.filterwarnings("ignore:Unexpected end-group tag")
def test_random_bytes_end_the_session_once_and_raise_nothing():
    chance = random.Random(7)
    whole = [examples()[name] for name in FROM_SERVERS] + [support.composite(1)]
    for _ in range(1500):
        data = bytearray(b"".join(chance.choices(whole, k=3)))
        for _ in range(chance.randrange(1, 6)):
            at = chance.randrange(len(data))
            kind = chance.randrange(3)
            if kind == 0:
                data[at] = chance.randrange(256)
            elif kind == 1:
                del data[at : at + chance.randrange(1, 9)]
            else:
                data[at:at] = chance.randbytes(chance.randrange(1, 9))
            if not data:
                break
        conversation = running()
        send(conversation)
        events, at = [], 0
        while at < len(data):
            size = chance.randrange(1, 200)
            events += conversation.receive(bytes(data[at : at + size]), 0)
            at += size
        events += conversation.lost(amalgam.SessionClosed("closed"))
        assert [type(e) for e in events].count(core.Ended) == 1
        assert isinstance(events[-1], core.Ended)


@pytest.mark.parametrize("body", ["hello", "camera_frame", "environment", "goodbye"])
def test_what_only_clients_send_is_refused(body):
    envelope = Envelope()
    getattr(envelope, body).SetInParent()
    (event,) = running().receive(encode(envelope), 0)
    assert isinstance(event.error, amalgam.ProtocolViolation)


def test_a_composite_before_the_welcome_and_a_second_welcome_are_refused():
    conversation = core.Conversation(core.make_hello(support.CAMERA, "", 0, None))
    (event,) = conversation.receive(support.composite(1), 0)
    assert isinstance(event.error, amalgam.ProtocolViolation)
    (event,) = running().receive(support.welcome(), 0)
    assert isinstance(event.error, amalgam.ProtocolViolation)


def test_pings_are_answered():
    conversation = running()
    conversation.receive(encode(Envelope(ping=Ping(nonce=9))), 0)
    assert conversation.take_output() == encode(Envelope(pong={"nonce": 9}))


def test_frames_are_accounted_for():
    conversation = running()
    first, second, third = (send(conversation, capture_time_us=1000) for _ in range(3))
    (event,) = conversation.receive(support.composite(second, 1000), 26000)
    assert event.skipped == (first,)
    assert event.composite.latency_ms == 25 and event.composite.stages == {"trace": 12.5}
    assert conversation.receive(support.composite(second), 0) == []  # a second answer
    assert conversation.receive(support.composite(77), 0) == []  # never sent
    (event,) = conversation.lost(amalgam.SessionClosed("closed"))
    assert event.unanswered == (third,)


def test_a_rejected_pose_is_a_warning_of_its_composite():
    conversation = running()
    frame = send(conversation)
    conversation.receive(support.error("POSE_REJECTED", frame), 0)
    (event,) = conversation.receive(support.composite(frame), 0)
    assert [type(w) for w in event.composite.warnings] == [amalgam.PoseRejected]


def test_draining_lets_frames_in_flight_end():
    conversation = running()
    frame = send(conversation)
    (event,) = conversation.receive(encode(Envelope(draining=Draining(deadline_ms=20000))), 0)
    assert event.error.deadline == 20
    with pytest.raises(amalgam.Draining):
        send(conversation)
    (event,) = conversation.receive(support.composite(frame), 0)
    assert event.composite.frame_id == frame
    (event,) = conversation.lost(amalgam.SessionClosed("closed"))
    assert isinstance(event.error, amalgam.Draining)


def test_busy_says_when_to_come_back():
    conversation = core.Conversation(core.make_hello(support.CAMERA, "", 0, None))
    (event,) = conversation.receive(encode(Envelope(busy=Busy(retry_after_ms=1500, reason="full"))), 0)
    assert isinstance(event.error, amalgam.Busy)
    assert (event.error.retry_after, event.error.reason) == (1.5, "full")


NO = float("nan")


@pytest.mark.parametrize("pose", [
    amalgam.Pose(40, (0, 0, 0, 1.01), (0, 0, 1)), amalgam.Pose(40, (0, 0, 0, NO), (0, 0, 1)),
    amalgam.Pose(40, (0, 0, 0, 1), (0, 0, NO)), amalgam.Pose(40, (0, 0, 0, 1), (0, -1.1e7, 1))])
def test_unusable_poses_are_not_sent(pose):
    conversation = running()
    with pytest.raises(amalgam.LimitError):
        send(conversation, poses=[pose])
    assert conversation.take_output() == b""


def test_other_limits_are_checked_before_sending():
    conversation = running()
    good = amalgam.Pose(40, (0, 0, 0, 1), (0, 0, 1))
    with pytest.raises(amalgam.TooManyPoses):
        send(conversation, poses=[good] * 65)
    with pytest.raises(amalgam.TooManyPoses):
        conversation.send_frame(support.plain_jpeg(), [good] * 33, [amalgam.Corners(40, ((0, 0),) * 4)] * 32, 0)
    for jpeg in (b"", b"no JPEG", support.plain_jpeg(support.WIDTH + 1), support.plain_jpeg()[:20]):
        with pytest.raises(amalgam.BadImage):
            conversation.send_frame(jpeg, (), (), 0)
    for pixels in (((0, 0),) * 3, ((0, 0),) * 3 + ((NO, 0),)):
        with pytest.raises(amalgam.LimitError):
            conversation.send_frame(support.plain_jpeg(), (), [amalgam.Corners(40, pixels)], 0)
    assert conversation.take_output() == b""
    assert send(conversation, poses=[good] * 64) == 1


@pytest.mark.parametrize("camera, token, quality", [
    (amalgam.Camera.from_fov(2049, 10), "", 0), (amalgam.Camera(10, 0, 9, 9, 0, 0), "", 0),
    (amalgam.Camera(10, 10, 0.5, 9, 0, 0), "", 0), (amalgam.Camera(10, 10, NO, 9, 0, 0), "", 0),
    (amalgam.Camera(10, 10, 9, 9, 0, NO), "", 0), (amalgam.Camera(10, 10, 9, 9, 0, 0, (0.0,) * 13), "", 0),
    (support.CAMERA, "é" * 513, 0), (support.CAMERA, "", 101)])
def test_a_hello_that_would_be_refused_is_not_sent(camera, token, quality):
    with pytest.raises(amalgam.LimitError):
        core.make_hello(camera, token, quality, None)


@pytest.mark.parametrize("text, address", [
    ("host", ("host", 7447)), ("host:1", ("host", 1)), ("[::1]:9", ("::1", 9)), ("::1", ("::1", 7447)),
    ("127.0.0.1:65535", ("127.0.0.1", 65535))])
def test_addresses(text, address):
    from amalgam.address import parse_address
    assert parse_address(text) == address


@pytest.mark.parametrize("text", ["", ":1", "host:", "host:0", "host:65536", "host:-1", "host:x"])
def test_what_is_no_address(text):
    from amalgam.address import parse_address
    with pytest.raises(amalgam.LimitError):
        parse_address(text)
