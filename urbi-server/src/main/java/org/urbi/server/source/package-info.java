/** Text on its way to a lobby: from options, files and modules. */
@NullMarked
package org.urbi.server.source;

import org.jspecify.annotations.NullMarked;
