package org.urbi.bridge;

/**
 * The functions of one library, mapped by JNA. Native methods belong to one library for all of
 * their class: each library gets a copy of this class, by a class loader of its own.
 */
public final class JnaFunctions implements ModuleFunctions {
  private final JnaHost host;

  /** Made by {@link JnaLibrary}, of its copy. */
  public JnaFunctions(JnaHost host) {
    this.host = host;
  }

  private static native long urbi_module_version();

  private static native long urbi_module_open(JnaHost host, long exchange);

  private static native long urbi_module_create(long exchange);

  private static native long urbi_module_destroy(long exchange);

  private static native long urbi_module_invoke(long exchange);

  private static native long urbi_module_forget(long exchange);

  private static native void urbi_module_free(long address);

  @Override
  public long version() {
    return urbi_module_version();
  }

  @Override
  public long open(long exchange) {
    return urbi_module_open(host, exchange);
  }

  @Override
  public long create(long exchange) {
    return urbi_module_create(exchange);
  }

  @Override
  public long destroy(long exchange) {
    return urbi_module_destroy(exchange);
  }

  @Override
  public long invoke(long exchange) {
    return urbi_module_invoke(exchange);
  }

  @Override
  public long forget(long exchange) {
    return urbi_module_forget(exchange);
  }

  @Override
  public void free(long address) {
    urbi_module_free(address);
  }
}
