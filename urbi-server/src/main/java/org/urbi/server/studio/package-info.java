/** The studio: people see and steer a running kernel in their browser (docs/studio.md). */
@NullMarked
package org.urbi.server.studio;

import org.jspecify.annotations.NullMarked;
