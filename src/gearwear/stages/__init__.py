"""Stages of the workflow after the wear history: functions from settings and datasets to what a rule writes.

The parameters of a stage are its settings `cfg`, the inputs of its rule and the wildcards of its output. Datasets are
written as netCDF, tables as CSV, text as it is.
"""
