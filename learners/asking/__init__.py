"""What people are asked: prospects, pairs of them, and the choices between them."""
