"""Jobs of the workflow: log, code digest, lock, checks of inputs."""
