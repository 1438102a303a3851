"""One scene under all its actions: what it is, its recording, its picture and its film."""
