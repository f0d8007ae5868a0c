"""REXS files of gearbox programs, versions 1.0 to 2.0, as cases; results back into them.

reading   XML, JSON and ZIP into one model (model.py)
names     attributes and units that are read, with all their names
drive     which parts rotate together; speeds and torques of each stage
stages    planetary stages as cases; pairs: gear pairs and single bearings
writing   the text of a case, and its way through the check
ledger    what was taken, what is missing, what was left out
results   results of a run back into the file
"""
