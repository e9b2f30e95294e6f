package org.urbi.bridge;

import java.nio.file.Path;
import urbi.UModule;
import urbi.spi.ModuleLoader;

/** Loads shared libraries as modules. */
public final class NativeModuleLoader implements ModuleLoader {
  private static final String SUFFIX =
      System.getProperty("os.name").startsWith("Windows") ? ".dll" : ".so";

  /** Made by the service loader. */
  public NativeModuleLoader() {}

  @Override
  public String suffix() {
    return SUFFIX;
  }

  @Override
  public UModule load(Path file) {
    return NativeModule.load(file).module();
  }
}
