package urbi;

/** How a UObject runs. */
public enum UObjectMode {
  /** In the process of the kernel. */
  MODE_PLUGIN,

  /** In a process of its own, connected to a kernel. */
  MODE_REMOTE
}
