"""Ctrl-C, and what a progress callback raises, end a call; the interpreter's lock is free meanwhile.

Signals are sent when a call reports progress, so that nothing depends on time.
"""
import os
import signal
import threading
import unittest

import numpy as np

import soms

POSES = np.zeros((200_000, 3))


class Interrupts(unittest.TestCase):
    def setUp(self):
        self.car = soms.Shape(soms.generate("car"))
        self.shares = []

    def ask(self, progress, threads=1):
        return soms.overlap(self.car, self.car, POSES, mode="any", threads=threads,
                            progress=progress)

    def interrupt(self, share):
        self.shares.append(share)
        if len(self.shares) == 1:
            os.kill(os.getpid(), signal.SIGINT)

    def check_ended_early(self):
        self.assertGreater(len(self.shares), 0)
        self.assertLess(self.shares[-1], 1)

    def test_ctrl_c_ends_a_batch(self):
        for threads in (1, 2):
            self.shares.clear()
            with self.assertRaises(KeyboardInterrupt):
                self.ask(self.interrupt, threads)
            self.check_ended_early()
        self.assertTrue(self.ask(None).any.all())

    def test_a_handler_that_is_set_later_is_followed(self):
        seen = []

        def handler(number, _):
            seen.append(number)
            raise InterruptedError

        before = signal.signal(signal.SIGINT, handler)
        try:
            with self.assertRaises(InterruptedError):
                self.ask(self.interrupt)
            self.check_ended_early()
        finally:
            signal.signal(signal.SIGINT, before)
        self.assertEqual(seen, [signal.SIGINT])
        self.shares.clear()
        with self.assertRaises(KeyboardInterrupt):
            self.ask(self.interrupt)
        self.check_ended_early()

    def test_a_handler_that_returns_leaves_an_error(self):
        before = signal.signal(signal.SIGINT, lambda *_: None)
        try:
            with self.assertRaises(soms.Error) as caught:
                self.ask(self.interrupt)
            self.assertEqual(caught.exception.kind, "cancelled")
        finally:
            signal.signal(signal.SIGINT, before)

    def test_other_threads_are_not_interrupted(self):
        answers = []
        worker = threading.Thread(target=lambda: answers.append(self.ask(None)))
        worker.start()
        with self.assertRaises(KeyboardInterrupt):
            self.ask(self.interrupt)
        worker.join()
        self.assertEqual(len(answers[0]), len(POSES))

    def test_what_progress_raises_ends_the_call(self):
        def stop(share):
            self.shares.append(share)
            raise LookupError("enough")

        for threads in (1, 2):
            self.shares.clear()
            with self.assertRaisesRegex(LookupError, "enough"):
                self.ask(stop, threads)
            self.assertEqual(len(self.shares), 1)

    def test_progress_of_a_call_in_another_thread_ends_it_too(self):
        raised = []

        def stop(_):
            raise LookupError

        def work():
            try:
                self.ask(stop)
            except LookupError as error:
                raised.append(error)

        worker = threading.Thread(target=work)
        worker.start()
        worker.join()
        self.assertEqual(len(raised), 1)

    def test_other_threads_run_meanwhile(self):
        ran = threading.Event()

        def wait(_):
            threading.Thread(target=ran.set).start()
            self.assertTrue(ran.wait())
            raise LookupError

        with self.assertRaises(LookupError):
            self.ask(wait)

    def test_a_call_within_a_call(self):
        def nested(share):
            self.shares.append(share)
            soms.overlap(self.car, self.car, mode="any")
            os.kill(os.getpid(), signal.SIGINT)

        with self.assertRaises(KeyboardInterrupt):
            self.ask(nested)
        self.check_ended_early()


if __name__ == "__main__":
    unittest.main()
