## What controls say.
