"""Result files: variables, netCDF, tables."""
