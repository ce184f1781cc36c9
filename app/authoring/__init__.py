"""Make and change action units, emotions and whole projects: pure functions from projects to projects.

`app.document.Document.edit` makes a step of what they return.
"""
