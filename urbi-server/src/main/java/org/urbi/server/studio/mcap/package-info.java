/** Recordings of variables as MCAP files, for Foxglove and programs like it (docs/recording.md). */
@NullMarked
package org.urbi.server.studio.mcap;

import org.jspecify.annotations.NullMarked;
