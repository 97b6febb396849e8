"""Who may use the inspector's server: those who have its token, from its own page only."""

from __future__ import annotations

import hmac
import secrets
from typing import Any, Awaitable, Callable

from aiohttp import web

# Trame's page would look for a launcher first, if it were not told where its server is.
_PAGE = "/index.html?sessionURL=ws%3A%2F%2FUSE_HOST%2Fws"
_HEADERS = {
    "Referrer-Policy": "no-referrer",
    "X-Content-Type-Options": "nosniff",
    "Cache-Control": "no-store",
}


class Guard:
    """Refuses all requests without the token, as an aiohttp middleware.

    The token comes in the address once. Then the browser has it as a cookie, and the address is free of it.
    """

    def __init__(self) -> None:
        self.token = secrets.token_urlsafe(32)

    def protect(self, application: web.Application) -> None:
        """Have each request of an application pass by."""
        application.middlewares.append(self._middleware())

    def _middleware(self) -> Any:
        @web.middleware
        async def checked(
            request: web.Request, handler: Callable[[web.Request], Awaitable[web.StreamResponse]]
        ) -> web.StreamResponse:
            if not _is_from_own_page(request):
                return web.Response(status=403, text="This request comes from another page.\n")
            if "token" in request.query:
                return self._welcome(request)
            if not self._knows(request.cookies.get(_cookie_name(request), "")):
                return web.Response(status=401, text="Open the whole address that the program printed.\n")
            try:
                response = await handler(request)
            except ConnectionResetError:  # the page is gone, and cannot be told
                return web.Response(status=400)
            if not response.prepared:
                response.headers.update(_HEADERS)
            return response

        return checked

    def _knows(self, token: str) -> bool:
        # What is no UTF-8 comes as surrogates.
        return hmac.compare_digest(token.encode(errors="surrogateescape"), self.token.encode())

    def _welcome(self, request: web.Request) -> web.StreamResponse:
        if not self._knows(request.query["token"]):
            return web.Response(status=401, text="This token is not the one that the program printed.\n")
        response = web.Response(status=302, headers={"Location": _PAGE, **_HEADERS})
        response.set_cookie(_cookie_name(request), self.token, httponly=True, samesite="Strict", path="/")
        return response


def _cookie_name(request: web.Request) -> str:
    """Browsers give cookies to all ports of a host, so that each port needs its own name."""
    local = request.transport.get_extra_info("sockname") if request.transport is not None else None
    return f"vitrine_{local[1] if local else 0}"


def _is_from_own_page(request: web.Request) -> bool:
    origin = request.headers.get("Origin")
    return origin is None or origin.split("://", 1)[-1] == request.host
