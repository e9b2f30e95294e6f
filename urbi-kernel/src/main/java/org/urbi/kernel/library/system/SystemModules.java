package org.urbi.kernel.library.system;

import java.nio.file.Path;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Optional;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiTypePart;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.library.file.FileAccess;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.outside.ConfinedException;
import org.urbi.kernel.outside.Outside;
import org.urbi.kernel.uobject.PluggedContext;
import urbi.UModuleException;
import urbi.rtp.RtpOptions;

/** Modules with UObjects (manual, "System": loadModule, loadLibrary). */
@UrbiTypePart(value = "System", needs = Permission.OWNER)
final class SystemModules {
  private final PluggedContext uobjects;
  private final Outside outside;

  SystemModules(PluggedContext uobjects, Outside outside) {
    this.uobjects = uobjects;
    this.outside = outside;
  }

  private Path file(Frame frame, CallSite site, UrbiObject module) {
    String name = frame.interpreter().asString(frame, module);
    Path working = FileAccess.anyPath(frame).working().path();
    Path found = uobjects.modules().find(working, Utf8Text.toJava(name));
    if (found == null) {
      throw frame
          .interpreter()
          .errors()
          .of(Problem.NO_FILE, name)
          .with("name", name)
          .with("routine", site.calledName())
          .build();
    }
    return found;
  }

  @Builtin(
      doc =
          "Loads the UObjects of a module; with \"isolate\" in a process of its own. One that is"
              + " loaded already is replaced if the file has changed; its objects stay.")
  void loadModule(
      Frame frame,
      CallSite site,
      UrbiObject self,
      UrbiObject module,
      @Optional @Nullable String options) {
    boolean isolate = "isolate".equals(options);
    if (!isolate && options != null && !options.isBlank()) {
      throw frame.error(site, Problem.MODULE_OPTION, options);
    }
    load(
        frame,
        site,
        module,
        file -> {
          if (isolate) {
            uobjects.modules().isolate(frame, file);
          } else {
            uobjects.modules().load(frame, file, false);
          }
        });
  }

  @Builtin(
      doc =
          "Loads a module whose classes can be used by those that are loaded later. It need not"
              + " have UObjects.")
  void loadLibrary(
      Frame frame,
      CallSite site,
      UrbiObject self,
      UrbiObject library,
      @Optional @Nullable String options) {
    load(frame, site, library, file -> uobjects.modules().load(frame, file, true));
  }

  /** Whether it is the module that has no file: it has values sent in datagrams. */
  private static boolean isRtp(Frame frame, UrbiObject module) {
    return frame.interpreter().asString(frame, module).equals(RtpOptions.MODULE);
  }

  private void load(Frame frame, CallSite site, UrbiObject module, Consumer<Path> how) {
    try {
      if (isRtp(frame, module)) {
        outside.confinement().checkConnections();
        uobjects.rtp().turn(true);
      } else {
        how.accept(file(frame, site, module));
      }
    } catch (UModuleException | ConfinedException e) {
      throw frame.error(site, Problem.REASON, Utf8Text.toUrbi(String.valueOf(e.getMessage())));
    }
  }

  @Builtin(doc = "Unloads a module: its objects are no longer UObjects.")
  void unloadModule(Frame frame, CallSite site, UrbiObject self, UrbiObject module) {
    boolean unloaded =
        isRtp(frame, module)
            ? uobjects.rtp().turn(false)
            : uobjects.modules().unload(frame, file(frame, site, module));
    if (!unloaded) {
      throw frame.error(site, Problem.NOT_LOADED, frame.interpreter().asString(frame, module));
    }
  }
}
