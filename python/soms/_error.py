"""The one exception of soms."""


class Error(ValueError):
    """What went wrong, where, and what to do.

    kind: a stable name that programs may branch on: usage, cannot_open, bad_file, empty_mesh,
    not_finite, out_of_range, not_rigid, not_closed, unsupported, out_of_memory, timed_out,
    cannot_write or cancelled.
    place: what it is about, such as "model.ply, line 17: vertex 90 of 88".
    remedy: what to do, such as "repair or drop the face".
    """

    def __init__(self, kind: str, place: str, remedy: str) -> None:
        super().__init__(f"{place}; {remedy}")
        self.kind = kind
        self.place = place
        self.remedy = remedy

    def __reduce__(self) -> tuple[type["Error"], tuple[str, str, str]]:
        return type(self), (self.kind, self.place, self.remedy)
