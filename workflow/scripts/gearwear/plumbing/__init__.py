"""What the stages share: settings, provenance, files, logs."""
