package org.urbi.kernel.library.system;

import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Optional;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiTypePart;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.library.file.FileAccess;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.SlotUpdate;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.outside.Network;
import org.urbi.kernel.outside.Outside;

/** What the program around the kernel does when code asks for it; the job waits, others run. */
@UrbiTypePart(value = "System", needs = Permission.OWNER)
final class SystemServices {
  private final HostServices services;
  private final Outside outside;

  SystemServices(HostServices services, Outside outside) {
    this.services = services;
    this.outside = outside;
  }

  @Builtin(
      doc =
          "Serves the studio on a port (0: any free one; 54080 if left out), unless it is served,"
              + " and returns its address.")
  String openStudio(Frame frame, CallSite site, UrbiObject self, @Optional @Nullable Double port) {
    double wanted = port == null ? HostServices.USUAL_PORT : port;
    if (port != null
        && (wanted != Math.rint(wanted) || wanted < 0 || wanted > Network.MAXIMUM_PORT)) {
      UrbiObject given = frame.interpreter().values().number(wanted);
      throw frame.error(
          site,
          Problem.REASON,
          Problem.INVALID_PORT.text(frame.interpreter().asPrintable(frame, given)));
    }
    String address = Utf8Text.toUrbi(await(frame, site, () -> services.openStudio((int) wanted)));
    SlotUpdate.assign(
        frame,
        frame.interpreter().world().prototype("System"),
        frame.interpreter().world().symbol("studio"),
        frame.interpreter().values().string(address));
    return address;
  }

  @Builtin(
      doc = "Records all variables, the jobs and the log to a file, for Foxglove and its kind.")
  void startMcap(Frame frame, CallSite site, UrbiObject self, UrbiObject file) {
    Path path = FileAccess.path(frame, site, 1, file).file();
    await(
        frame,
        site,
        () -> {
          services.startMcap(path);
          return true;
        });
  }

  @Builtin(doc = "Ends what startMcap has begun; the file is complete then.")
  void stopMcap(Frame frame, CallSite site, UrbiObject self) {
    await(
        frame,
        site,
        () -> {
          services.stopMcap();
          return true;
        });
  }

  private <T> T await(Frame frame, CallSite site, Callable<T> work) {
    try {
      return outside.await(frame.job(), work);
    } catch (IOException e) {
      throw frame.error(site, Problem.REASON, Utf8Text.toUrbi(String.valueOf(e.getMessage())));
    }
  }
}
