"""The medium of pixels: tools that every picture and film is drawn with, without a display."""
