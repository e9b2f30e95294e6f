package org.urbi.ros.rtps;

/** Bytes that are no RTPS: what is left of their datagram is ignored. */
final class MalformedException extends Exception {
  MalformedException(String what) {
    // A hostile peer may send a hundred thousand of them a second: they carry no stack trace.
    super(what, null, false, false);
  }
}
