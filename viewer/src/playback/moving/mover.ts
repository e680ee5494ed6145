// SPDX-License-Identifier: Apache-2.0
// The switch that lets starts, goals and obstacles be moved, where somebody begins the run anew with them.
import { h } from '../../common/dom';
import type { StageView } from '../scene/stage_view';
import type { Source } from '../source';
import { Handles } from './handles';

export class Mover {
  readonly button = h('button', {
    type: 'button', class: 'switch mover', 'aria-pressed': 'false', title: 'Move starts, goals and obstacles (e)', click: () => this.toggle(),
  }, 'Move');
  readonly handles: Handles;
  private on = false;

  constructor(private readonly source: Source, stage: StageView) {
    this.handles = new Handles(stage, (path, position_m) => source.moved(path, position_m));
    source.on_handles((handles) => {
      this.on = handles.length > 0;
      this.button.setAttribute('aria-pressed', String(this.on));
      this.handles.show(handles);
    });
  }

  toggle(): void {
    this.source.edit(!this.on);
  }
}
