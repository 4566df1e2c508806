"""Effect of every option and open parameter on the results."""
