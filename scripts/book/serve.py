"""Serves the book on this machine alone."""

import functools
import http.server


class Quiet(http.server.SimpleHTTPRequestHandler):
    """Says nothing about what it serves."""

    def log_message(self, *_):
        pass


def make_server(site, port):
    """A server of 127.0.0.1 that waits to be run; the port 0 takes any that is free."""
    handler = functools.partial(Quiet, directory=str(site))
    return http.server.ThreadingHTTPServer(("127.0.0.1", port), handler)


def serve(site, port):
    """Until Ctrl-C."""
    try:
        server = make_server(site, port)
    except OSError:
        server = make_server(site, 0)
    print(f"The book is at http://127.0.0.1:{server.server_port}/ until Ctrl-C.", flush=True)
    try:
        server.serve_forever()
    except KeyboardInterrupt:
        print()
    finally:
        server.server_close()
