"""serve.py FOLDER [--port N] [--lessons FOLDER]: a static server for one's own machine.

It answers on 127.0.0.1 only, names types as browsers want them, asks the browser to check each
file anew (304 when it has not changed) and packs what packs well, so that transfer sizes are what
a real host's would be.

With --lessons it serves the lessons of that folder in place of the site's own, as they are at that
moment, and preview.json, by which the page sees that one was saved.
"""

import argparse
import errno
import functools
import gzip
import hashlib
import os
import subprocess
import sys
import urllib.parse
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer

from drafts import Drafts

TYPES = {
    ".css": "text/css; charset=utf-8",
    ".html": "text/html; charset=utf-8",
    ".js": "text/javascript; charset=utf-8",
    ".json": "application/json",
    ".mjs": "text/javascript; charset=utf-8",
    ".otf": "font/otf",
    ".ply": "application/octet-stream",
    ".png": "image/png",
    ".svg": "image/svg+xml",
    ".toml": "text/plain; charset=utf-8",
    ".ttf": "font/ttf",
    ".wasm": "application/wasm",
    ".webmanifest": "application/manifest+json",
}
PACKED_ALREADY = {".png"}


@functools.lru_cache(maxsize=256)
def load(path, modified, size):
    """The file's bytes, its gzipped bytes or None, and a tag of its content."""
    with open(path, "rb") as file:
        plain = file.read()
    packed = None
    if os.path.splitext(path)[1] not in PACKED_ALREADY:
        packed = gzip.compress(plain, 6, mtime=0)
    return plain, packed, hashlib.sha256(plain).hexdigest()[:16]


class Handler(SimpleHTTPRequestHandler):
    protocol_version = "HTTP/1.1"

    def __init__(self, *args, drafts=None, **named):
        self.drafts = drafts
        super().__init__(*args, **named)

    def do_GET(self, with_body=True):
        name = urllib.parse.unquote(urllib.parse.urlsplit(self.path).path).lstrip("/")
        if self.drafts and self.drafts.has(name):
            return self.send_draft(name, with_body)
        path = self.translate_path(self.path)
        if os.path.isdir(path):
            path = os.path.join(path, "index.html")
        try:
            status = os.stat(path)
            plain, packed, tag = load(path, status.st_mtime_ns, status.st_size)
        except OSError:
            return self.send_error(404)
        gzipped = packed is not None and "gzip" in self.headers.get("Accept-Encoding", "")
        body = packed if gzipped else plain
        etag = f'"{tag}{"-gz" if gzipped else ""}"'
        same = etag in self.headers.get("If-None-Match", "")
        self.send_response(304 if same else 200)
        self.send_header("ETag", etag)
        self.send_header("Cache-Control", "no-cache")
        self.send_header("Vary", "Accept-Encoding")
        self.send_header("Last-Modified", self.date_time_string(status.st_mtime))
        if not same:
            self.send_type(path)
            self.send_header("Content-Length", str(len(body)))
            if gzipped:
                self.send_header("Content-Encoding", "gzip")
        self.end_headers()
        if with_body and not same:
            self.wfile.write(body)

    def send_draft(self, name, with_body):
        """What changes while it is served is never kept by the browser."""
        try:
            body = self.drafts.read(name)
        except (OSError, ValueError, subprocess.SubprocessError):
            return self.send_error(404)
        self.send_response(200)
        self.send_header("Cache-Control", "no-store")
        self.send_type(name)
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        if with_body:
            self.wfile.write(body)

    def send_type(self, path):
        self.send_header("Content-Type", TYPES.get(os.path.splitext(path)[1], "application/octet-stream"))
        self.send_header("X-Content-Type-Options", "nosniff")

    def do_HEAD(self):
        self.do_GET(with_body=False)

    def log_message(self, *args):
        pass  # the terminal is for people


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder")
    parser.add_argument("--port", type=int, default=8000, help="0 takes any that is free")
    parser.add_argument("--lessons", metavar="FOLDER", help="the lessons to serve in place of the site's own")
    options = parser.parse_args()
    drafts = None
    if options.lessons is not None:
        drafts = Drafts(options.lessons, options.folder)
        if wrong := drafts.wrong():
            sys.exit(wrong)
    handler = functools.partial(Handler, directory=options.folder, drafts=drafts)
    try:
        server = ThreadingHTTPServer(("127.0.0.1", options.port), handler)
    except (OSError, OverflowError) as error:
        if getattr(error, "errno", None) == errno.EADDRINUSE:
            reason = f"Port {options.port} is in use: choose another one, ./run --port {options.port + 1}."
        else:
            reason = f"Port {options.port} cannot be opened: choose another one with --port."
        sys.exit(reason)
    what = f", with the lessons of {options.lessons}" if drafts else ""
    print(f"Snug is at http://127.0.0.1:{server.server_port}/{what} (Ctrl+C ends it)", flush=True)
    try:
        server.serve_forever()
    except KeyboardInterrupt:
        print()


main()
