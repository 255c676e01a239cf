'use strict';
// Draws the page from the data of one plan. Everything that comes from the plan becomes text
// nodes, never markup.
(() => {
  const report = JSON.parse(document.getElementById('report-data').textContent);
  const byId = (id) => document.getElementById(id);
  const svgNode = (name, attributes) => {
    const node = document.createElementNS('http://www.w3.org/2000/svg', name);
    for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
    return node;
  };

  byId('title').textContent = report.title;
  byId('reason').textContent = report.reason;

  // Tables: columns are {name, number?, value(row), text(row)?}.
  function fillTable(table, columns, rows, decorate) {
    const head = table.createTHead().insertRow();
    const body = table.createTBody();
    columns.forEach((column) => {
      const cell = document.createElement('th');
      cell.textContent = column.name;
      if (column.number) cell.className = 'number';
      head.append(cell);
    });
    const draw = (ordered) => {
      body.replaceChildren();
      ordered.forEach((row) => {
        const line = body.insertRow();
        columns.forEach((column) => {
          const cell = line.insertCell();
          if (column.number) cell.className = 'number';
          cell.append(column.node ? column.node(row) : (column.text || column.value)(row) ?? '');
        });
        if (decorate) decorate(line, row);
      });
    };
    draw(rows);
    return {head, draw};
  }

  // The map with what is pointed at on top of it.
  const map = byId('map');
  const image = document.createElement('img');
  image.src = report.map.image;
  image.alt = report.title;
  const overlay =
      svgNode('svg', {viewBox: `0 0 ${report.map.width} ${report.map.height}`, role: 'img'});
  const ghost = svgNode('polyline', {
    fill: 'none', stroke: '#c8102e', 'stroke-width': 5, 'stroke-linejoin': 'round',
    visibility: 'hidden'});
  const marker = svgNode('circle', {
    r: 9, fill: '#ffd400', stroke: '#000', 'stroke-width': 2, visibility: 'hidden'});
  overlay.append(ghost, marker);
  map.append(image, overlay);

  const route = report.route;
  const charts = [];
  let current = -1;

  function describe(row) {
    const parts = [`${route.s[row].toFixed(0)} m`, `${route.t[row].toFixed(1)} s`];
    report.charts.forEach((chart) => chart.series.forEach((series) => {
      const value = route.columns[series.column][row];
      if (value !== null) parts.push(`${series.name} ${value}${chart.unit ? ' ' + chart.unit : ''}`);
    }));
    return parts.join(' · ');
  }

  function showRow(row) {
    if (row === current) return;
    current = row;
    const visible = row >= 0;
    marker.setAttribute('visibility', visible ? 'visible' : 'hidden');
    if (visible) {
      marker.setAttribute('cx', route.x[row]);
      marker.setAttribute('cy', route.y[row]);
    }
    byId('here').textContent = visible ? describe(row) : '';
    charts.forEach((chart) => chart.draw());
  }

  function nearestByDistance(s) {
    let low = 0, high = route.s.length - 1;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (route.s[middle] < s) low = middle + 1; else high = middle;
    }
    return low > 0 && s - route.s[low - 1] < route.s[low] - s ? low - 1 : low;
  }

  function nearestByPixel(x, y) {
    let best = -1, least = 60 * 60;
    route.x.forEach((px, i) => {
      const square = (px - x) ** 2 + (route.y[i] - y) ** 2;
      if (square < least) { least = square; best = i; }
    });
    return best;
  }

  const crosshair = {
    id: 'crosshair',
    afterDraw(chart) {
      if (current < 0) return;
      const x = chart.scales.x.getPixelForValue(route.s[current]);
      const {top, bottom} = chart.chartArea;
      chart.ctx.save();
      chart.ctx.strokeStyle = '#000';
      chart.ctx.beginPath();
      chart.ctx.moveTo(x, top);
      chart.ctx.lineTo(x, bottom);
      chart.ctx.stroke();
      chart.ctx.restore();
    },
  };

  function addChart(spec) {
    const box = document.createElement('div');
    box.className = 'chart';
    const canvas = document.createElement('canvas');
    canvas.setAttribute('aria-label', spec.title);
    box.append(canvas);
    byId('charts').append(box);
    const points = (values) => route.s.map((s, i) => ({x: s, y: values[i]}));
    const ends = [0, Math.ceil(route.s[route.s.length - 1])];
    const datasets = spec.series.map((series) => ({
      label: series.name, data: points(route.columns[series.column]), borderColor: series.color,
      borderWidth: 1.5, pointRadius: 0}));
    (spec.limits || []).forEach((limit, i) => datasets.push({
      label: i === 0 ? 'limit' : '', data: ends.map((s) => ({x: s, y: limit})),
      borderColor: '#c8102e', borderDash: [6, 4], borderWidth: 1, pointRadius: 0}));
    const chart = new Chart(canvas, {
      type: 'line', data: {datasets}, plugins: [crosshair],
      options: {
        animation: false, parsing: false, normalized: true, maintainAspectRatio: false,
        plugins: {
          title: {display: true, align: 'start', text: spec.title, padding: {top: 2, bottom: 2}},
          legend: {labels: {boxWidth: 14, boxHeight: 2, filter: (item) => item.text !== ''},
                   align: 'end', position: 'top'},
          tooltip: {enabled: false}},
        scales: {
          x: {type: 'linear', min: ends[0], max: ends[1], ticks: {maxTicksLimit: 8}},
          y: {ticks: {maxTicksLimit: 6}, title: {display: spec.unit !== '', text: spec.unit}}}},
    });
    canvas.addEventListener('mousemove', (event) => {
      showRow(nearestByDistance(chart.scales.x.getValueForPixel(event.offsetX)));
    });
    canvas.addEventListener('mouseleave', () => showRow(-1));
    charts.push(chart);
  }

  if (route) {
    report.charts.forEach(addChart);
    map.addEventListener('mousemove', (event) => {
      const scale = report.map.width / map.clientWidth;
      const box = map.getBoundingClientRect();
      showRow(nearestByPixel((event.clientX - box.left) * scale,
                             (event.clientY - box.top) * scale));
    });
    map.addEventListener('mouseleave', () => showRow(-1));
  } else {
    byId('chart-section').remove();
    byId('limit-section').remove();
  }

  if (route) {
    fillTable(byId('limits'), [
      {name: 'limit', value: (row) => row.name},
      {name: 'worst', number: true, value: (row) => row.worst},
      {name: 'allowed', number: true, value: (row) => row.limit},
      {name: 'margin left', number: true, value: (row) => `${(100 * row.margin).toFixed(0)} %`},
      {name: 'after', number: true, value: (row) => `${row.s.toFixed(0)} m`},
      {name: 'place', value: (row) => row.place},
    ], report.limits, (line, row) => {
      if (row.binding) line.className = 'marked';
      line.addEventListener('mouseenter', () => showRow(nearestByDistance(row.s)));
      line.addEventListener('mouseleave', () => showRow(-1));
    });
  }

  fillTable(byId('rounds'), report.rounds.columns.map((name, i) => (
      {name, number: i > 0, value: (row) => row[i]})), report.rounds.rows);

  // Candidates, sorted by score at first.
  const outcome = (row) => {
    const swatch = document.createElement('span');
    swatch.className = 'swatch';
    swatch.style.background = row.color;
    const cell = document.createElement('span');
    cell.append(swatch, row.outcome);
    return cell;
  };
  const columns = [
    {name: 'id', number: true, value: (row) => row.id},
    {name: 'round', value: (row) => row.round},
    {name: 'origin', value: (row) => row.origin},
    {name: 'outcome', value: (row) => row.outcome, node: outcome},
    {name: 'score', number: true, value: (row) => row.score ?? Infinity,
     text: (row) => row.score === null ? '–' : row.score.toFixed(1)},
    {name: 'time [s]', number: true, value: (row) => row.time, text: (row) => row.time.toFixed(1)},
    {name: 'driven [m]', number: true, value: (row) => row.length,
     text: (row) => row.length.toFixed(0)},
    {name: 'of its way', number: true, value: (row) => row.progress,
     text: (row) => `${(100 * row.progress).toFixed(0)} %`},
    {name: 'ended at', value: (row) => row.place},
    {name: 'reason', value: (row) => row.reason},
  ];
  report.extraColumns.forEach((name, i) => columns.splice(
      5 + i, 0, {name, number: true, value: (row) => row.extra[i] ?? ''}));
  const ordered = [...report.candidates];
  const table = fillTable(byId('candidates'), columns, [], (line, row) => {
    if (row.chosen) line.className = 'marked';
    line.addEventListener('mouseenter', () => {
      ghost.setAttribute('points', row.line);
      ghost.setAttribute('visibility', 'visible');
    });
    line.addEventListener('mouseleave', () => ghost.setAttribute('visibility', 'hidden'));
  });
  let sortedBy = null, rising = true;
  const sortBy = (column) => {
    rising = sortedBy === column ? !rising : true;
    sortedBy = column;
    ordered.sort((a, b) => {
      const one = column.value(a), other = column.value(b);
      const order = one < other ? -1 : one > other ? 1 : a.id - b.id;
      return rising ? order : -order;
    });
    table.draw(ordered);
  };
  [...table.head.cells].forEach((cell, i) =>
    cell.addEventListener('click', () => sortBy(columns[i])));
  sortBy(columns.find((column) => column.name === 'score'));

  fillTable(byId('basis'), [
    {name: '', value: (row) => row[0]}, {name: '', value: (row) => row[1]}], report.basis);
})();
