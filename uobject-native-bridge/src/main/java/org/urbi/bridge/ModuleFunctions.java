package org.urbi.bridge;

/**
 * The functions that a library of UObjects exports, see {@code urbi/detail/boundary.h}. All but
 * {@link #version} and {@link #free} take the address of an {@link Exchange}, and return {@link
 * Exchange#FAILED} where C++ code has thrown an exception.
 */
public interface ModuleFunctions {
  /** The version of the boundary. */
  long version();

  /** Tells it whom to ask: from now on it may call back. */
  long open(long exchange);

  /** Makes an object; returns its address. */
  long create(long exchange);

  /** Deletes an object. */
  long destroy(long exchange);

  /** Calls a callback. */
  long invoke(long exchange);

  /** A context is no longer used. */
  long forget(long exchange);

  /** Frees a reply that the library has allocated. */
  void free(long address);
}
