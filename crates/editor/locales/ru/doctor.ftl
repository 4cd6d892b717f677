## Why a picture is black, white or empty.
