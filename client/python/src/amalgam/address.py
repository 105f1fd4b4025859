"""Where a server is, and whether it is trusted."""

from __future__ import annotations

import os
import ssl
from typing import Optional, Tuple, Union

from .errors import ConnectFailed, LimitError

DEFAULT_PORT = 7447

Path = Union[str, "os.PathLike[str]"]


def parse_address(text: str) -> Tuple[str, int]:
    """host, host:port, or [IPv6]:port."""
    host, colon, port = text.rpartition(":")
    if not colon or (":" in host and not host.endswith("]")):
        host, port = text, str(DEFAULT_PORT)
    if host.startswith("[") and host.endswith("]"):
        host = host[1:-1]
    if not host or not port.isascii() or not port.isdigit() or not 0 < int(port) < 65536:
        raise LimitError(f"a server is HOST:PORT and not {text!r}")
    return host, int(port)


def tls_context(tls: Union[bool, ssl.SSLContext], ca: Optional[Path]) -> Optional[ssl.SSLContext]:
    """TLS 1.3, and the server's certificate must be for its name. ca: PEM of those trusted; else the system's."""
    if isinstance(tls, ssl.SSLContext):
        return tls
    if not tls:
        if ca is not None:
            raise LimitError("ca needs tls=True")
        return None
    try:
        context = ssl.create_default_context(cafile=None if ca is None else os.fspath(ca))
    except (OSError, ssl.SSLError) as error:
        raise ConnectFailed(f"certificates {ca}: {error}") from None
    context.minimum_version = ssl.TLSVersion.TLSv1_3
    return context
