import pathlib
import signal
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))  # for the module `meshes`

# Shells let what runs in the background ignore Ctrl-C.
signal.signal(signal.SIGINT, signal.default_int_handler)
