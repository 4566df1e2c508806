"""Search of the parameters that the reference paper leaves open, against its claims about the motion."""
