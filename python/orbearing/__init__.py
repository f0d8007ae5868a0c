"""Plots and reports made from the results of Orbearing."""
